package org.dfra.core.budget;

import java.io.Serializable;

/**
 * What one account of a budget has used. Means are over the last {@value RateMeter#WINDOW_SECONDS}
 * s.
 *
 * @param budget its name
 * @param scope whose account it is
 * @param owner the caller or object
 * @param limits of the account
 * @param bytes per second
 * @param calls per second
 * @param processorTime in seconds per second
 * @param listeners registered now
 * @param refused calls and listeners since the policy is in force
 * @param slowed calls since then
 * @param thinned readings that its listeners did not get, since then
 */
public record BudgetUse(
    String budget,
    Budget.Scope scope,
    String owner,
    BudgetLimits limits,
    double bytes,
    double calls,
    double processorTime,
    int listeners,
    long refused,
    long slowed,
    long thinned)
    implements Serializable {}
