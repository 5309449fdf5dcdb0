/**
 * The directory of modules without a network, and what every directory has in common.
 *
 * <pre>
 *   register / a lookup service --&gt; ModuleTable --&gt; find, findFirst, personas
 *                                        |---------&gt; ListenerNotifier --&gt; a listener
 *                                        +---------&gt; FailoverHandler (proxyFor)
 * </pre>
 *
 * <p>Enter at {@link org.dfra.core.directory.InMemoryModuleDirectory}. The distributed layer's
 * directory extends {@link org.dfra.core.directory.CachedModuleDirectory} too and fills its table
 * from lookup services, so that both answer alike.
 */
@NullMarked
package org.dfra.core.directory;

import org.jspecify.annotations.NullMarked;
