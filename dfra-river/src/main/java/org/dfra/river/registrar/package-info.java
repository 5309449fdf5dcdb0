/**
 * Decides which registrations a robot's registrar accepts from which computer.
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
 * <p>Enter at {@link org.dfra.river.registrar.RegistrarILFactory}, which the configuration of the
 * registrar's exporter names.
 */
@NullMarked
package org.dfra.river.registrar;

import org.jspecify.annotations.NullMarked;
