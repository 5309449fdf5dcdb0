/**
 * The persona: what a robot shows of itself to others, module by module.
 *
 * <pre>
 *   module --Described--&gt; Attributes (records here) --&gt; a lookup service, as entries
 *                                                            |
 *   client &lt;--ModuleListing-- ModuleDirectory &lt;--------------+
 * </pre>
 *
 * <p>Enter at {@link org.dfra.persona.Attributes}. The records here are what queries name; how they
 * travel is the distributed layer's matter. A driver may have a record of its own beside these.
 */
@NullMarked
package org.dfra.persona;

import org.jspecify.annotations.NullMarked;
