/**
 * Robots on two hosts, which are network namespaces of this machine.
 *
 * <pre>
 *   host 0: phoenix, reggie, its modules, client ── switch ── host 1: the same of another robot
 *      │                                                         │
 *      └── serial cables ── simulated world (of searchers) ──────┘
 * </pre>
 *
 * <p>Enter at {@link org.dfra.hosts.TwoHostsIT}, and at {@link org.dfra.hosts.TwoSearchersIT} for
 * robots that drive meanwhile.
 */
package org.dfra.hosts;
