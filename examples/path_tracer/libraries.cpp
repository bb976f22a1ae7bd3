// Where the readers that come as headers are compiled. (What writes pictures: ../common/stb.cpp.)
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
