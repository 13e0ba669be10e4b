// SPDX-License-Identifier: Apache-2.0
#include "handwritten_forms.h"

#include <array>

namespace nazori::writing {
namespace {

constexpr std::array kForms{
    // One bowl and a stem.
    HandwrittenForm{U'a', "M72,52C67,43 54,43 46,48C32,56 30,78 42,87C52,94 68,88 72,78|M72,45L72,92"},
    HandwrittenForm{
        U'a', "M72,52C67,43 54,43 46,48C32,56 30,78 42,87C52,94 68,88 72,78|M72,45L72,80C72,90 78,92 86,88"},
    HandwrittenForm{U'b', "M36,15L36,92C60,92 74,88 74,72C74,56 60,52 36,56"},
    HandwrittenForm{U'd', "M74,58C64,46 32,46 31,70C30,92 62,94 74,80|M74,15L74,82C74,90 80,92 86,88"},
    HandwrittenForm{U'e', "M30,68L76,64C76,44 36,38 30,66C26,96 66,96 78,84"},
    HandwrittenForm{U'f', "M78,22C70,10 52,12 52,32L52,108|M34,50L74,50"},
    HandwrittenForm{U'f', "M74,22C66,12 52,14 52,32L52,98C52,110 40,112 32,106|M36,50L72,50"},
    // An open tail.
    HandwrittenForm{U'g', "M72,50C64,36 34,36 32,58C30,80 64,80 72,64|M72,40L72,94C72,112 40,114 30,102"},
    HandwrittenForm{
        U'g',
        "M72,46C60,32 34,38 33,54C32,70 62,72 72,58|M72,38L72,86C72,104 30,112 28,96C28,90 40,88 52,88"},
    HandwrittenForm{U'h', "M36,15L36,92|M36,64C42,48 72,44 72,66L72,92"},
    HandwrittenForm{U'i', "M50,42L50,80C50,92 62,92 68,86|M50,20L51,23"},
    HandwrittenForm{U'i', "M40,42L52,42L52,90|M38,90L66,90|M50,20L51,23"},
    HandwrittenForm{U'j', "M66,36L66,90C66,108 32,112 26,94|M66,14L67,17"},
    HandwrittenForm{U'j', "M50,36L66,36L66,90C66,108 36,112 30,100|M66,14L67,17"},
    HandwrittenForm{U'k', "M36,15L36,92|M74,44L36,68L76,92"},
    HandwrittenForm{U'k', "M36,15L36,92|M36,66C50,40 74,42 70,56C66,66 50,66 40,68L76,92"},
    HandwrittenForm{U'l', "M50,15L50,80C50,92 62,92 68,86"},
    HandwrittenForm{U'l', "M40,15L52,15L52,90|M36,90L68,90"},
    HandwrittenForm{U'l', "M40,86C56,70 66,20 54,16C42,12 42,84 54,90C60,92 66,88 70,82"},
    HandwrittenForm{U'm', "M20,44L20,92|M20,60C26,42 52,42 52,64L52,92|M52,62C56,42 86,42 86,66L86,92"},
    HandwrittenForm{U'n', "M32,44L32,92|M32,62C40,42 74,42 74,68L74,92"},
    HandwrittenForm{U'p', "M36,40L36,112|M36,52C44,36 78,36 78,62C78,86 46,88 36,74"},
    HandwrittenForm{U'q', "M72,50C64,36 34,36 32,60C30,84 64,84 72,68|M72,40L72,110L84,98"},
    HandwrittenForm{U'q', "M72,50C64,36 34,36 32,60C30,84 64,84 72,68|M72,40L72,112|M62,96L82,96"},
    HandwrittenForm{U'r', "M40,42L40,92|M40,62C44,48 58,40 76,48"},
    HandwrittenForm{U't', "M54,20L54,92|M32,44L76,44"},
    HandwrittenForm{U't', "M54,20L54,92|M24,40L86,40"},
    HandwrittenForm{U't', "M50,20L50,80C50,94 66,94 76,84|M32,44L72,44"},
    HandwrittenForm{U'u', "M32,44L32,72C32,98 74,98 74,72L74,44"},
    HandwrittenForm{U'w', "M22,44L22,70C22,96 54,96 54,70L54,52|M54,70C54,96 86,96 86,70L86,44"},
    HandwrittenForm{U'x', "M30,46C48,42 50,62 54,68C58,78 62,94 80,88|M80,46C62,48 44,88 28,90"},
    HandwrittenForm{U'y', "M30,42L54,76|M80,42L38,112"},
    HandwrittenForm{U'y', "M32,42L32,64C32,86 74,86 74,64|M74,42L74,94C74,112 42,114 32,102"},
    HandwrittenForm{U'z', "M30,46L78,46L30,90L80,90|M40,68L70,68"},
    HandwrittenForm{U'A', "M20,92L54,14L88,92|M33,62L75,62"},
    HandwrittenForm{U'A', "M24,92L24,44C24,8 84,8 84,44L84,92|M24,58L84,58"},
    HandwrittenForm{U'E', "M78,22C60,8 34,16 36,34C38,48 52,50 58,50C40,50 26,60 30,76C36,96 68,94 80,82"},
    HandwrittenForm{U'F', "M34,15L34,92|M34,15L80,15|M34,52L72,52"},
    HandwrittenForm{U'G', "M82,28C68,8 24,8 22,54C20,98 76,102 82,74L82,58L58,58"},
    HandwrittenForm{U'G', "M82,28C68,8 24,8 22,54C20,98 76,102 82,74L82,58|M58,58L92,58"},
    HandwrittenForm{U'I', "M54,15L54,92|M34,15L74,15|M34,92L74,92"},
    HandwrittenForm{U'J', "M62,15L62,74C62,98 30,98 26,76|M40,15L84,15"},
    HandwrittenForm{U'K', "M32,15L32,92|M80,15L32,58L84,92"},
    HandwrittenForm{U'M', "M22,92L30,15L54,74L78,15L86,92"},
    HandwrittenForm{U'M', "M20,15L20,92|M20,15L54,56L88,15|M88,15L88,92"},
    HandwrittenForm{U'Q', "M54,15C10,15 10,92 54,92C98,92 98,15 54,15|M56,70L88,100"},
    HandwrittenForm{U'R', "M30,15L30,92|M30,16C90,6 92,58 30,54L84,92"},
    HandwrittenForm{U'U', "M26,15L26,62C26,102 82,102 82,62L82,15|M82,15L82,92"},
    HandwrittenForm{U'Y', "M24,15L54,52|M88,15L36,92"},
    HandwrittenForm{U'Y', "M26,15L26,34C26,60 82,60 82,34|M82,15L82,72C82,98 40,100 32,84"},
    HandwrittenForm{U'Z', "M26,15L84,15L24,92L86,92|M38,54L70,54"},
    HandwrittenForm{U'0', "M54,15C18,15 18,92 54,92C90,92 90,15 54,15|M76,22L32,86"},
    HandwrittenForm{U'1', "M54,15L54,92"},
    HandwrittenForm{U'1', "M36,34L56,15L56,92|M34,92L78,92"},
    HandwrittenForm{U'2', "M30,36C34,8 78,8 76,38C74,62 48,74 34,88C44,74 56,96 80,86"},
    HandwrittenForm{U'3', "M30,15L76,15L48,48C88,42 88,92 54,92C40,92 32,86 28,78"},
    HandwrittenForm{U'4', "M40,15L30,58L82,58|M68,34L68,94"},
    HandwrittenForm{U'4', "M70,92L70,15L24,68L86,68"},
    HandwrittenForm{U'6', "M68,15C44,24 30,50 30,70C30,98 78,98 78,70C78,48 40,46 32,68"},
    HandwrittenForm{U'7', "M28,15L80,15L44,92"},
    HandwrittenForm{U'7', "M28,15L80,15L44,92|M40,54L76,54"},
    HandwrittenForm{U'8', "M74,26C62,6 30,14 36,36C42,54 78,56 78,76C78,98 30,98 30,76C30,56 74,54 74,26"},
    HandwrittenForm{U'9', "M76,40C76,8 30,8 30,38C30,64 70,62 76,38L76,92"},
};

}  // namespace

std::span<const HandwrittenForm> handwritten_forms() { return kForms; }

}  // namespace nazori::writing
