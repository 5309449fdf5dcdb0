/**
 * The budgets of a robot's process: what callers and listeners have used, and how much the network
 * of its computer carries.
 *
 * <p>Start at {@link org.dfra.river.security.budget.ProcessBudgets}. {@link
 * org.dfra.river.security.budget.BudgetMonitor} is how commands ask a process.
 */
@NullMarked
package org.dfra.river.security.budget;

import org.jspecify.annotations.NullMarked;
