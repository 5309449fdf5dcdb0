/** Smart proxies of behaviours. Enter at {@link org.dfra.river.proxy.behavior.BehaviorProxy}. */
@NullMarked
package org.dfra.river.proxy.behavior;

import org.jspecify.annotations.NullMarked;
