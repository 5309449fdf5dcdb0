/**
 * Small robots that act by themselves: their behaviours, and the agents that call each other for
 * help.
 *
 * <p>Enter at {@link org.dfra.autonomy.BehaviorsTest}.
 */
package org.dfra.autonomy;
