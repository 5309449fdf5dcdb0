/**
 * Who may do what with a team's robots: rules in XML, of which the first that matches decides.
 *
 * <pre>
 *   policy.xml --PolicyXml.read--&gt; Policy --&gt; PolicyGuard --&gt; Decision
 *                    ^              PolicyRule       ^  |
 *   InterfaceCatalogue                      PolicyFacts '--&gt; DecisionListener
 * </pre>
 *
 * <p>Start at {@link org.dfra.core.policy.PolicyGuard}, which decides about calls, or at {@link
 * org.dfra.core.policy.PolicyXml}, which reads a policy. {@link
 * org.dfra.core.policy.method.MethodKinds} says what kind of method each remote method is. {@link
 * org.dfra.core.policy.PolicyBundle} is a signed policy. The reference for users is {@code
 * docs/reference/policy.md}.
 */
@NullMarked
package org.dfra.core.policy;

import org.jspecify.annotations.NullMarked;
