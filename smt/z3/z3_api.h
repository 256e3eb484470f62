#pragma once
#include <new>
#include <z3.h>

#include "smt/z3/shared_library.h"

/// Z3's C++ interface without linking Z3: its library is loaded when the first of its functions is called, as
/// most runs call none and starting with it takes longer than many a search.
///
/// Each function is a line below; another one that is called without a line is undefined to the linker.

namespace solitaire {

/// Throws std::runtime_error if there is no Z3.
const SharedLibrary& z3_library();

/// The function of Z3 that `F` declares.
template <auto* F>
decltype(F) z3_function(const char* name) {
  static const auto function = reinterpret_cast<decltype(F)>(z3_library().symbol(name));
  return function;
}

/// Throws std::bad_alloc where Z3 gives null, at which its C++ interface does not look.
inline Z3_context make_z3_context(Z3_config config) {
  const Z3_context made = z3_function<&::Z3_mk_context_rc>("Z3_mk_context_rc")(config);
  if (made == nullptr) throw std::bad_alloc();
  return made;
}

}  // namespace solitaire

#define SOLITAIRE_Z3(name) solitaire::z3_function<&::name>(#name)

#define Z3_ast_vector_dec_ref SOLITAIRE_Z3(Z3_ast_vector_dec_ref)
#define Z3_ast_vector_get SOLITAIRE_Z3(Z3_ast_vector_get)
#define Z3_ast_vector_inc_ref SOLITAIRE_Z3(Z3_ast_vector_inc_ref)
#define Z3_ast_vector_push SOLITAIRE_Z3(Z3_ast_vector_push)
#define Z3_ast_vector_size SOLITAIRE_Z3(Z3_ast_vector_size)
#define Z3_benchmark_to_smtlib_string SOLITAIRE_Z3(Z3_benchmark_to_smtlib_string)
#define Z3_dec_ref SOLITAIRE_Z3(Z3_dec_ref)
#define Z3_del_config SOLITAIRE_Z3(Z3_del_config)
#define Z3_del_context SOLITAIRE_Z3(Z3_del_context)
#define Z3_get_ast_id SOLITAIRE_Z3(Z3_get_ast_id)
#define Z3_get_ast_kind SOLITAIRE_Z3(Z3_get_ast_kind)
#define Z3_get_bv_sort_size SOLITAIRE_Z3(Z3_get_bv_sort_size)
#define Z3_get_error_code SOLITAIRE_Z3(Z3_get_error_code)
#define Z3_get_error_msg SOLITAIRE_Z3(Z3_get_error_msg)
#define Z3_get_numeral_uint64 SOLITAIRE_Z3(Z3_get_numeral_uint64)
#define Z3_get_sort SOLITAIRE_Z3(Z3_get_sort)
#define Z3_get_sort_kind SOLITAIRE_Z3(Z3_get_sort_kind)
#define Z3_inc_ref SOLITAIRE_Z3(Z3_inc_ref)
#define Z3_interrupt SOLITAIRE_Z3(Z3_interrupt)
#define Z3_is_re_sort SOLITAIRE_Z3(Z3_is_re_sort)
#define Z3_is_seq_sort SOLITAIRE_Z3(Z3_is_seq_sort)
#define Z3_mk_add SOLITAIRE_Z3(Z3_mk_add)
#define Z3_mk_and SOLITAIRE_Z3(Z3_mk_and)
#define Z3_mk_ast_vector SOLITAIRE_Z3(Z3_mk_ast_vector)
#define Z3_mk_bool_sort SOLITAIRE_Z3(Z3_mk_bool_sort)
#define Z3_mk_bv_sort SOLITAIRE_Z3(Z3_mk_bv_sort)
#define Z3_mk_bvadd SOLITAIRE_Z3(Z3_mk_bvadd)
#define Z3_mk_bvmul SOLITAIRE_Z3(Z3_mk_bvmul)
#define Z3_mk_bvneg SOLITAIRE_Z3(Z3_mk_bvneg)
#define Z3_mk_bvsdiv SOLITAIRE_Z3(Z3_mk_bvsdiv)
#define Z3_mk_bvsle SOLITAIRE_Z3(Z3_mk_bvsle)
#define Z3_mk_bvslt SOLITAIRE_Z3(Z3_mk_bvslt)
#define Z3_mk_bvsmod SOLITAIRE_Z3(Z3_mk_bvsmod)
#define Z3_mk_bvsrem SOLITAIRE_Z3(Z3_mk_bvsrem)
#define Z3_mk_bvsub SOLITAIRE_Z3(Z3_mk_bvsub)
#define Z3_mk_bvudiv SOLITAIRE_Z3(Z3_mk_bvudiv)
#define Z3_mk_bvule SOLITAIRE_Z3(Z3_mk_bvule)
#define Z3_mk_bvult SOLITAIRE_Z3(Z3_mk_bvult)
#define Z3_mk_bvurem SOLITAIRE_Z3(Z3_mk_bvurem)
#define Z3_mk_concat SOLITAIRE_Z3(Z3_mk_concat)
#define Z3_mk_config SOLITAIRE_Z3(Z3_mk_config)
#define Z3_mk_const SOLITAIRE_Z3(Z3_mk_const)
#define Z3_mk_context_rc solitaire::make_z3_context
#define Z3_mk_distinct SOLITAIRE_Z3(Z3_mk_distinct)
#define Z3_mk_div SOLITAIRE_Z3(Z3_mk_div)
#define Z3_mk_eq SOLITAIRE_Z3(Z3_mk_eq)
#define Z3_mk_extract SOLITAIRE_Z3(Z3_mk_extract)
#define Z3_mk_false SOLITAIRE_Z3(Z3_mk_false)
#define Z3_mk_fpa_add SOLITAIRE_Z3(Z3_mk_fpa_add)
#define Z3_mk_fpa_div SOLITAIRE_Z3(Z3_mk_fpa_div)
#define Z3_mk_fpa_leq SOLITAIRE_Z3(Z3_mk_fpa_leq)
#define Z3_mk_fpa_lt SOLITAIRE_Z3(Z3_mk_fpa_lt)
#define Z3_mk_fpa_mul SOLITAIRE_Z3(Z3_mk_fpa_mul)
#define Z3_mk_fpa_neg SOLITAIRE_Z3(Z3_mk_fpa_neg)
#define Z3_mk_fpa_rna SOLITAIRE_Z3(Z3_mk_fpa_rna)
#define Z3_mk_fpa_rne SOLITAIRE_Z3(Z3_mk_fpa_rne)
#define Z3_mk_fpa_rtn SOLITAIRE_Z3(Z3_mk_fpa_rtn)
#define Z3_mk_fpa_rtp SOLITAIRE_Z3(Z3_mk_fpa_rtp)
#define Z3_mk_fpa_rtz SOLITAIRE_Z3(Z3_mk_fpa_rtz)
#define Z3_mk_fpa_sub SOLITAIRE_Z3(Z3_mk_fpa_sub)
#define Z3_mk_implies SOLITAIRE_Z3(Z3_mk_implies)
#define Z3_mk_int SOLITAIRE_Z3(Z3_mk_int)
#define Z3_mk_int64 SOLITAIRE_Z3(Z3_mk_int64)
#define Z3_mk_ite SOLITAIRE_Z3(Z3_mk_ite)
#define Z3_mk_le SOLITAIRE_Z3(Z3_mk_le)
#define Z3_mk_lt SOLITAIRE_Z3(Z3_mk_lt)
#define Z3_mk_mul SOLITAIRE_Z3(Z3_mk_mul)
#define Z3_mk_not SOLITAIRE_Z3(Z3_mk_not)
#define Z3_mk_or SOLITAIRE_Z3(Z3_mk_or)
#define Z3_mk_params SOLITAIRE_Z3(Z3_mk_params)
#define Z3_mk_re_concat SOLITAIRE_Z3(Z3_mk_re_concat)
#define Z3_mk_re_union SOLITAIRE_Z3(Z3_mk_re_union)
#define Z3_mk_seq_concat SOLITAIRE_Z3(Z3_mk_seq_concat)
#define Z3_mk_sign_ext SOLITAIRE_Z3(Z3_mk_sign_ext)
#define Z3_mk_solver SOLITAIRE_Z3(Z3_mk_solver)
#define Z3_mk_solver_for_logic SOLITAIRE_Z3(Z3_mk_solver_for_logic)
#define Z3_mk_string_symbol SOLITAIRE_Z3(Z3_mk_string_symbol)
#define Z3_mk_sub SOLITAIRE_Z3(Z3_mk_sub)
#define Z3_mk_true SOLITAIRE_Z3(Z3_mk_true)
#define Z3_mk_unary_minus SOLITAIRE_Z3(Z3_mk_unary_minus)
#define Z3_mk_zero_ext SOLITAIRE_Z3(Z3_mk_zero_ext)
#define Z3_model_dec_ref SOLITAIRE_Z3(Z3_model_dec_ref)
#define Z3_model_eval SOLITAIRE_Z3(Z3_model_eval)
#define Z3_model_inc_ref SOLITAIRE_Z3(Z3_model_inc_ref)
#define Z3_params_dec_ref SOLITAIRE_Z3(Z3_params_dec_ref)
#define Z3_params_inc_ref SOLITAIRE_Z3(Z3_params_inc_ref)
#define Z3_params_set_bool SOLITAIRE_Z3(Z3_params_set_bool)
#define Z3_params_set_symbol SOLITAIRE_Z3(Z3_params_set_symbol)
#define Z3_params_set_uint SOLITAIRE_Z3(Z3_params_set_uint)
#define Z3_set_ast_print_mode SOLITAIRE_Z3(Z3_set_ast_print_mode)
#define Z3_set_error_handler SOLITAIRE_Z3(Z3_set_error_handler)
#define Z3_solver_assert SOLITAIRE_Z3(Z3_solver_assert)
#define Z3_solver_check SOLITAIRE_Z3(Z3_solver_check)
#define Z3_solver_check_assumptions SOLITAIRE_Z3(Z3_solver_check_assumptions)
#define Z3_solver_dec_ref SOLITAIRE_Z3(Z3_solver_dec_ref)
#define Z3_solver_from_string SOLITAIRE_Z3(Z3_solver_from_string)
#define Z3_solver_get_assertions SOLITAIRE_Z3(Z3_solver_get_assertions)
#define Z3_solver_get_model SOLITAIRE_Z3(Z3_solver_get_model)
#define Z3_solver_get_reason_unknown SOLITAIRE_Z3(Z3_solver_get_reason_unknown)
#define Z3_solver_get_unsat_core SOLITAIRE_Z3(Z3_solver_get_unsat_core)
#define Z3_solver_inc_ref SOLITAIRE_Z3(Z3_solver_inc_ref)
#define Z3_solver_set_params SOLITAIRE_Z3(Z3_solver_set_params)

#include <z3++.h>
