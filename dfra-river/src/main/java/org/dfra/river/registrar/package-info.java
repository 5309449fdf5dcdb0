/**
 * What a robot's registrar takes from whom.
 *
 * <pre>
 *   register, notify, addAttributes, ... --&gt; RegistrarDispatcher --&gt; reggie
 *                                                |
 *          EntryClaims: robots that entries name |  ReggieState: what reggie holds now
 *                                                v
 *                                        RegistrationRules: service ID --&gt; computer
 * </pre>
 *
 * <p>Enter at {@link org.dfra.river.registrar.RegistrarILFactory}, which the registrar's exporter
 * is configured with.
 */
@NullMarked
package org.dfra.river.registrar;

import org.jspecify.annotations.NullMarked;
