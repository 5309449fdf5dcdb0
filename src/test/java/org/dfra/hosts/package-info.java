/**
 * Robots on two hosts, which are network namespaces of this machine.
 *
 * <pre>
 *   host 0: phoenix, reggie, 2 × GPS, client ── switch ── host 1: the same of another robot
 * </pre>
 *
 * <p>Enter at {@link org.dfra.hosts.TwoHostsIT}.
 */
package org.dfra.hosts;
