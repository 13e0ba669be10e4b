// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "nazori/functions/expression.h"

namespace nazori::functions {

// The names that can be typed, in small letters.

struct FunctionName {
  std::u32string_view text;
  Function function;
};

inline constexpr FunctionName kFunctions[] = {
    {U"sin", Function::sin},           {U"cos", Function::cos},
    {U"tan", Function::tan},           {U"tg", Function::tan},
    {U"cot", Function::cot},           {U"ctg", Function::cot},
    {U"sec", Function::sec},           {U"csc", Function::csc},
    {U"cosec", Function::csc},         {U"asin", Function::asin},
    {U"arcsin", Function::asin},       {U"acos", Function::acos},
    {U"arccos", Function::acos},       {U"atan", Function::atan},
    {U"arctan", Function::atan},       {U"acot", Function::acot},
    {U"arccot", Function::acot},       {U"sinh", Function::sinh},
    {U"cosh", Function::cosh},         {U"tanh", Function::tanh},
    {U"coth", Function::coth},         {U"sech", Function::sech},
    {U"csch", Function::csch},         {U"asinh", Function::asinh},
    {U"arsinh", Function::asinh},      {U"arcsinh", Function::asinh},
    {U"acosh", Function::acosh},       {U"arcosh", Function::acosh},
    {U"arccosh", Function::acosh},     {U"atanh", Function::atanh},
    {U"artanh", Function::atanh},      {U"arctanh", Function::atanh},
    {U"exp", Function::exp},           {U"ln", Function::ln},
    {U"log", Function::log10},         {U"lg", Function::log10},
    {U"sqrt", Function::sqrt},         {U"cbrt", Function::cbrt},
    {U"root", Function::root},         {U"abs", Function::abs},
    {U"sign", Function::sign},         {U"sgn", Function::sign},
    {U"signum", Function::sign},       {U"floor", Function::floor},
    {U"ceil", Function::ceil},         {U"ceiling", Function::ceil},
    {U"round", Function::round},       {U"trunc", Function::trunc},
    {U"frac", Function::fraction},     {U"gamma", Function::gamma},
    {U"erf", Function::erf},           {U"factorial", Function::factorial},
    {U"min", Function::min},           {U"max", Function::max},
    {U"mod", Function::mod},           {U"hypot", Function::hypot},
    {U"integral", Function::integral},
};
// Names that end in digits, and log_b (base first), stand only where a parenthesis follows: "log2(x)", but
// "log2x" is log(2x).
inline constexpr FunctionName kNumberedFunctions[] = {{U"log2", Function::log2},
                                                      {U"log10", Function::log10},
                                                      {U"log_b", Function::log_base},
                                                      {U"atan2", Function::atan2}};

struct VariableName {
  std::u32string_view text;
  Variable variable;
};
inline constexpr VariableName kVariables[] = {{U"x", Variable::x},         {U"y", Variable::y},
                                              {U"z", Variable::z},         {U"t", Variable::t},
                                              {U"theta", Variable::theta}, {U"r", Variable::r}};
struct ConstantName {
  std::u32string_view text;
  Constant constant;
};
inline constexpr ConstantName kConstants[] = {
    {U"pi", Constant::pi}, {U"e", Constant::e}, {U"tau", Constant::tau}};

}  // namespace nazori::functions
