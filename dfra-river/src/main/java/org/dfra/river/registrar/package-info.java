/**
 * What a robot's registrar takes from whom.
 *
 * <pre>
 *   register, notify, addAttributes, ... --&gt; RegistrarDispatcher --&gt; reggie
 *                                                |
 *     ReggieArgumentValidator: what no client would send |  ReggieState: what reggie holds now
 *          RobotClaimReader: robots that entries name |  EntryDescriptorReader: classes of entries
 *                                                v
 *                                        RegistrationRules: service ID --&gt; computer, bytes
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.registrar.RegistrarILFactory}, which the registrar's exporter
 * is configured with.
 */
@NullMarked
package org.dfra.river.registrar;

import org.jspecify.annotations.NullMarked;
