/**
 * Phoenix: the activation daemon, and the virtual machines of its groups.
 *
 * <pre>
 *   clients --activate--&gt; ActivatorService -+
 *   local   --register--&gt; SystemService  ---+--&gt; Daemon --&gt; Group --&gt; GroupProcess --&gt; GroupVm
 *   groups  --report----&gt; MonitorService ---+       |                                   |
 *                                                Journal (fsynced)          ActivationGroupImpl
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.phoenix.Phoenix} for the daemon's process, at {@link
 * org.dfra.river.phoenix.PhoenixDaemon} for its logic, at {@link org.dfra.river.phoenix.GroupVm}
 * for the other side. Group virtual machines outlive the daemon: a restarted one reads its journal,
 * takes back the living and starts a new one only where the old one is proven dead.
 */
@NullMarked
package org.dfra.river.phoenix;

import org.jspecify.annotations.NullMarked;
