// A Vulkan device that runs a compute shader over arrays: one buffer in, one out, 64 invocations a group.
#pragma once

#include <vulkan/vulkan.h>

#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace shader_tests {

class device {
public:
    device(std::size_t bytes_in, std::size_t bytes_out) : given_size(bytes_in), found_size(bytes_out) {
        VkApplicationInfo application{};
        application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
        application.apiVersion = VK_API_VERSION_1_1;
        VkInstanceCreateInfo create{};
        create.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
        create.pApplicationInfo = &application;
        check(vkCreateInstance(&create, nullptr, &instance), "no Vulkan (Debian: mesa-vulkan-drivers)");
        std::uint32_t count = 1;
        vkEnumeratePhysicalDevices(instance, &count, &physical);
        if (!count) throw std::runtime_error("no Vulkan device (Debian: mesa-vulkan-drivers)");
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(physical, &properties);
        name = properties.deviceName;

        const float priority = 1;
        VkDeviceQueueCreateInfo queue_of{};
        queue_of.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
        queue_of.queueCount = 1;
        queue_of.pQueuePriorities = &priority;
        VkDeviceCreateInfo device_of{};
        device_of.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
        device_of.queueCreateInfoCount = 1;
        device_of.pQueueCreateInfos = &queue_of;
        check(vkCreateDevice(physical, &device_of, nullptr, &logical), "vkCreateDevice");
        vkGetDeviceQueue(logical, 0, 0, &queue);
        given = buffer(given_size, given_at);
        found = buffer(found_size, found_at);
        bind();
    }
    device(const device&) = delete;
    device& operator=(const device&) = delete;

    void load(const std::vector<float>& inputs) { std::memcpy(given_at, inputs.data(), inputs.size() * sizeof(float)); }

    /// Runs a SPIR-V file; what it wrote.
    const float* run(const std::string& file, std::uint32_t groups) {
        std::ifstream stream(file, std::ios::binary | std::ios::ate);
        if (!stream) throw std::runtime_error(file + " cannot be read");
        std::vector<std::uint32_t> code(static_cast<std::size_t>(stream.tellg()) / 4);
        stream.seekg(0).read(reinterpret_cast<char*>(code.data()), static_cast<std::streamsize>(code.size() * 4));
        VkShaderModuleCreateInfo module_of{};
        module_of.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
        module_of.codeSize = code.size() * 4;
        module_of.pCode = code.data();
        VkShaderModule module;
        check(vkCreateShaderModule(logical, &module_of, nullptr, &module), "vkCreateShaderModule");
        VkComputePipelineCreateInfo pipeline_of{};
        pipeline_of.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
        pipeline_of.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        pipeline_of.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
        pipeline_of.stage.module = module;
        pipeline_of.stage.pName = "main";
        pipeline_of.layout = layout;
        VkPipeline pipeline;
        check(vkCreateComputePipelines(logical, VK_NULL_HANDLE, 1, &pipeline_of, nullptr, &pipeline), "pipeline");

        std::memset(found_at, 0xff, found_size);  // NaN where nothing is written
        VkCommandBufferBeginInfo begin{};
        begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
        check(vkBeginCommandBuffer(commands, &begin), "commands");
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, nullptr);
        vkCmdDispatch(commands, groups, 1, 1);
        check(vkEndCommandBuffer(commands), "commands");
        VkSubmitInfo submit{};
        submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
        submit.commandBufferCount = 1;
        submit.pCommandBuffers = &commands;
        check(vkQueueSubmit(queue, 1, &submit, VK_NULL_HANDLE), "submit");
        check(vkQueueWaitIdle(queue), "wait");
        vkDestroyPipeline(logical, pipeline, nullptr);
        vkDestroyShaderModule(logical, module, nullptr);
        return static_cast<const float*>(found_at);
    }

    std::string name;

private:
    static void check(VkResult result, const char* what) {
        if (result != VK_SUCCESS) throw std::runtime_error(std::string(what) + ": VkResult " + std::to_string(result));
    }

    VkBuffer buffer(std::size_t size, void*& at) {
        VkBufferCreateInfo create{};
        create.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
        create.size = size;
        create.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
        VkBuffer made;
        check(vkCreateBuffer(logical, &create, nullptr, &made), "vkCreateBuffer");
        VkMemoryRequirements needs;
        vkGetBufferMemoryRequirements(logical, made, &needs);
        VkPhysicalDeviceMemoryProperties memory;
        vkGetPhysicalDeviceMemoryProperties(physical, &memory);
        VkMemoryAllocateInfo allocate{};
        allocate.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
        allocate.allocationSize = needs.size;
        const VkMemoryPropertyFlags wanted = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
        while (!(needs.memoryTypeBits >> allocate.memoryTypeIndex & 1u) ||
               (memory.memoryTypes[allocate.memoryTypeIndex].propertyFlags & wanted) != wanted)
            ++allocate.memoryTypeIndex;
        VkDeviceMemory memory_of_it;
        check(vkAllocateMemory(logical, &allocate, nullptr, &memory_of_it), "vkAllocateMemory");
        check(vkBindBufferMemory(logical, made, memory_of_it, 0), "vkBindBufferMemory");
        check(vkMapMemory(logical, memory_of_it, 0, VK_WHOLE_SIZE, 0, &at), "vkMapMemory");
        return made;
    }

    void bind() {
        VkDescriptorSetLayoutBinding bindings[2]{};
        for (std::uint32_t i = 0; i < 2; ++i) {
            bindings[i].binding = i;
            bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
            bindings[i].descriptorCount = 1;
            bindings[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
        }
        VkDescriptorSetLayoutCreateInfo set_layout_of{};
        set_layout_of.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
        set_layout_of.bindingCount = 2;
        set_layout_of.pBindings = bindings;
        VkDescriptorSetLayout set_layout;
        check(vkCreateDescriptorSetLayout(logical, &set_layout_of, nullptr, &set_layout), "layout");
        VkPipelineLayoutCreateInfo layout_of{};
        layout_of.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
        layout_of.setLayoutCount = 1;
        layout_of.pSetLayouts = &set_layout;
        check(vkCreatePipelineLayout(logical, &layout_of, nullptr, &layout), "layout");
        const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2};
        VkDescriptorPoolCreateInfo pool_of{};
        pool_of.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
        pool_of.maxSets = 1;
        pool_of.poolSizeCount = 1;
        pool_of.pPoolSizes = &size;
        VkDescriptorPool pool;
        check(vkCreateDescriptorPool(logical, &pool_of, nullptr, &pool), "pool");
        VkDescriptorSetAllocateInfo allocate{};
        allocate.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
        allocate.descriptorPool = pool;
        allocate.descriptorSetCount = 1;
        allocate.pSetLayouts = &set_layout;
        check(vkAllocateDescriptorSets(logical, &allocate, &set), "set");
        const VkDescriptorBufferInfo buffers[2]{{given, 0, VK_WHOLE_SIZE}, {found, 0, VK_WHOLE_SIZE}};
        for (std::uint32_t i = 0; i < 2; ++i) {
            VkWriteDescriptorSet write{};
            write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
            write.dstSet = set;
            write.dstBinding = i;
            write.descriptorCount = 1;
            write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
            write.pBufferInfo = &buffers[i];
            vkUpdateDescriptorSets(logical, 1, &write, 0, nullptr);
        }
        VkCommandPoolCreateInfo commands_of{};
        commands_of.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        commands_of.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
        VkCommandPool command_pool;
        check(vkCreateCommandPool(logical, &commands_of, nullptr, &command_pool), "commands");
        VkCommandBufferAllocateInfo buffer_of{};
        buffer_of.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        buffer_of.commandPool = command_pool;
        buffer_of.commandBufferCount = 1;
        check(vkAllocateCommandBuffers(logical, &buffer_of, &commands), "commands");
    }

    std::size_t given_size, found_size;
    VkInstance instance{};
    VkPhysicalDevice physical{};
    VkDevice logical{};
    VkQueue queue{};
    VkBuffer given{}, found{};
    void *given_at{}, *found_at{};
    VkPipelineLayout layout{};
    VkDescriptorSet set{};
    VkCommandBuffer commands{};
};

}  // namespace shader_tests
