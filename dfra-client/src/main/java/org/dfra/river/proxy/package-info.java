/**
 * Smart proxies, which clients download and call. The third of the five classes.
 *
 * <pre>
 *   client --&gt; GPSProxy --same virtual machine--&gt; the implementation (LocalModuleRegistry)
 *                      \--anywhere else---------&gt; RemoteGPSSensor --&gt; GPSServer
 * </pre>
 *
 * <p>A proxy depends on the remote interfaces and the API, never on a server's class, since clients
 * download it.
 */
@NullMarked
package org.dfra.river.proxy;

import org.jspecify.annotations.NullMarked;
