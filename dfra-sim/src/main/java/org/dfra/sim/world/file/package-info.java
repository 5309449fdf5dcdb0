/**
 * Files of a world: its XML, and GeoJSON with its objects.
 *
 * <pre>
 *   world.xml --WorldXml.read--&gt; WorldDescription --WorldXml.write--&gt; world.xml
 *      |  features
 *      v
 *   field.geojson
 * </pre>
 *
 * <p>Enter at {@link org.dfra.sim.world.file.WorldXml}. Invalid input causes a {@link
 * org.dfra.core.config.ConfigurationException} that names all errors, a line each: file and line,
 * cause, remedy. The reference for users is {@code docs/reference/world-xml.md}.
 */
@NullMarked
package org.dfra.sim.world.file;

import org.jspecify.annotations.NullMarked;
