/**
 * Phoenix: the activation daemon, and the virtual machines of its groups.
 *
 * <pre>
 *   clients --activate--&gt; ActivatorService -+
 *   local   --register--&gt; SystemService  ---+--&gt; GroupRegistry --&gt; Journal (fsynced)
 *   groups  --report----&gt; MonitorService ---+          |
 *   anybody --stop------&gt; StopServiceImpl --+--&gt; GroupTable --&gt; ManagedGroup
 *                                                                  | GroupLauncher
 *                                                             GroupProcess
 *                                                                  | starts
 *                                                             GroupVm, ActivationGroupImpl
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.phoenix.Phoenix} for the daemon's process, at {@link
 * org.dfra.river.phoenix.PhoenixDaemon} for its parts, at {@link org.dfra.river.phoenix.GroupVm}
 * for the group's process. Group virtual machines outlive the daemon. A restarted daemon reads its
 * journal, adopts the running ones, and starts a new one only if the old one has certainly exited.
 */
@NullMarked
package org.dfra.river.phoenix;

import org.jspecify.annotations.NullMarked;
