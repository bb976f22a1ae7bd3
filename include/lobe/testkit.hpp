// The test kit: it judges any BRDF, distribution of normals, Fresnel reflectance or point set, and includes no model of lobe.
#pragma once

#include <lobe/testkit/adapters.hpp>
#include <lobe/testkit/distribution.hpp>
#include <lobe/testkit/fresnel.hpp>
#include <lobe/testkit/sequence.hpp>
#include <lobe/testkit/verify.hpp>
