/**
 * Discovery: finds lookup services on the network, with readers that an unknown host's response
 * cannot exhaust.
 *
 * <pre>
 *   announcements, UDP --&gt; DiscoveryCandidates -\
 *                                               +-&gt; UnicastDiscovery, 4 at once -&gt; registrars
 *   responses to requests --&gt; ResponseListener -/          ^
 *                                                          |
 *   locators (package lookup) -----------------------------+
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.discovery.UnicastDiscovery} for one known host, at {@link
 * org.dfra.river.discovery.MulticastSearch} for groups.
 */
@NullMarked
package org.dfra.river.discovery;

import org.jspecify.annotations.NullMarked;
