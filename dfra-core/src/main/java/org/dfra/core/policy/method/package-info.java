/**
 * Which remote methods there are, and of which kind each one is: what rules of a policy speak of.
 *
 * <pre>
 *   remote-interfaces.tsv --&gt; InterfaceCatalogue --&gt; MethodKinds, CalledMethod
 * </pre>
 *
 * <p>Start at {@link org.dfra.core.policy.method.MethodKinds}. The kinds are explained in {@code
 * docs/reference/policy.md}.
 */
@NullMarked
package org.dfra.core.policy.method;

import org.jspecify.annotations.NullMarked;
