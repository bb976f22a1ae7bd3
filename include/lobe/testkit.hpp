// The test kit: it judges any BRDF, distribution of normals, Fresnel reflectance or point set, and includes no model of
// lobe.
#pragma once

#include <lobe/testkit/compare.hpp>
#include <lobe/testkit/subject/adapters.hpp>
#include <lobe/testkit/verify.hpp>
#include <lobe/testkit/verify_distribution.hpp>
#include <lobe/testkit/verify_fresnel.hpp>
#include <lobe/testkit/verify_sequence.hpp>
