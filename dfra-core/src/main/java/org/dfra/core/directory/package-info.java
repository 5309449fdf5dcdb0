/**
 * The directory of modules without a network, and the base of every directory.
 *
 * <pre>
 *   register / a lookup service --&gt; ModuleTable --&gt; find, findFirst, personas
 *                                        |---------&gt; ListenerNotifier --&gt; a listener
 *                                        +---------&gt; FailoverHandler (proxyFor)
 * </pre>
 *
 * <p>Start at {@link org.dfra.core.directory.InMemoryModuleDirectory}. The distributed layer's
 * directory extends {@link org.dfra.core.directory.CachedModuleDirectory} too and fills its table
 * from lookup services, so that both behave alike.
 */
@NullMarked
package org.dfra.core.directory;

import org.jspecify.annotations.NullMarked;
