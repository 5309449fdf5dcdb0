/**
 * What a robot's registrar has beside reggie. It decides which registrations are accepted from
 * which computer.
 *
 * <pre>
 *   register, notify, addAttributes, ... --&gt; RegistrarDispatcher --&gt; reggie
 *                                                |
 *    ReggieArgumentValidator: valid arguments    |  ReggieState: reggie's present contents
 *    RobotClaimReader: robots named in entries   |  EntryDescriptorReader: classes of entries
 *                                                v
 *                                        RegistrationRules: service ID --&gt; computer, bytes
 * </pre>
 *
 * <p>For callers from whom a policy hides something, it answers in place of reggie:
 *
 * <pre>
 *   lookup, getFieldValues, ... --&gt; RegistrarDispatcher --&gt; VisibleLookup --&gt; ReggieMatcher
 *   events of reggie --&gt; VisibleEvents (an EventFilter)      VisibleItems: items as they are seen
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.registrar.RegistrarILFactory}, which the configuration of the
 * registrar's exporter names. {@link org.dfra.river.registrar.RegistrarLeaseLimiter} shortens
 * leases after a step of the clock. {@link org.dfra.river.registrar.DiscoveryServerSocketFactory}
 * and {@link org.dfra.river.registrar.RegistrarTaskManager} keep silent peers from holding reggie's
 * threads.
 */
@NullMarked
package org.dfra.river.registrar;

import org.jspecify.annotations.NullMarked;
