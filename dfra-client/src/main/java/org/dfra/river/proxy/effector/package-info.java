/** Smart proxies of effectors. Enter at {@link org.dfra.river.proxy.effector.EffectorProxy}. */
@NullMarked
package org.dfra.river.proxy.effector;

import org.jspecify.annotations.NullMarked;
