/**
 * The persona: the attributes that a robot publishes, module by module.
 *
 * <pre>
 *   module --AttributeProvider--&gt; Attributes (records) --&gt; a lookup service, as entries
 *                                                            |
 *   client &lt;--ModuleListing-- ModuleDirectory &lt;--------------+
 * </pre>
 *
 * <p>Start at {@link org.dfra.persona.Attributes}. Queries name the records here; the distributed
 * layer transports them. A driver may define further records.
 */
@NullMarked
package org.dfra.persona;

import org.jspecify.annotations.NullMarked;
