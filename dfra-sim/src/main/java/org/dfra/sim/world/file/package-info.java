/**
 * How a world is written down: its XML, and GeoJSON with what lies in it.
 *
 * <pre>
 *   world.xml --WorldXml.read--&gt; WorldDescription --WorldXml.write--&gt; world.xml
 *      |  features
 *      v
 *   field.geojson
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.world.file.WorldXml}. Whatever cannot be used ends in a {@link
 * org.dfra.core.config.ConfigurationException} that names all of it, a line each: file and line,
 * what is wrong, what to do. The reference for users is {@code docs/reference/world-xml.md}.
 */
@NullMarked
package org.dfra.sim.world.file;

import org.jspecify.annotations.NullMarked;
