/**
 * Budgets: what callers, and modules, may use of a robot in a second. A guard refuses or slows the
 * calls beyond, and the readings of listeners become fewer.
 *
 * <pre>
 *   policy --&gt; Budgets --&gt; BudgetGuard: around the guard that decides who may call
 *                            | BudgetAccount, one for each caller or module of a budget
 *                            | ListenerShare, one for each remote listener
 *   radio's rate --&gt; RadioThinning: readings of listeners of low priority become fewer first
 * </pre>
 *
 * <p>Start at {@link org.dfra.core.budget.BudgetGuard}. The policy that declares budgets is read by
 * {@code org.dfra.core.policy}; the reference for users is {@code docs/reference/policy.md}.
 */
@NullMarked
package org.dfra.core.budget;

import org.jspecify.annotations.NullMarked;
