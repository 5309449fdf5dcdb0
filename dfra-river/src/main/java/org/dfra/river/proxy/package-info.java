/**
 * Smart proxies: what clients hold. The third of the five classes.
 *
 * <pre>
 *   client --&gt; GPSProxy --same virtual machine--&gt; the implementation (LocalModuleRegistry)
 *                      \--anywhere else---------&gt; RemoteGPSSensor --&gt; GPSServer
 * </pre>
 *
 * <p>A proxy depends on the remote interfaces and the API, never on a server's class: it is what
 * travels.
 */
@NullMarked
package org.dfra.river.proxy;

import org.jspecify.annotations.NullMarked;
