/**
 * Servers of perceptual and motor schemas. Enter at {@link
 * org.dfra.river.server.schema.SchemaServer}.
 */
@NullMarked
package org.dfra.river.server.schema;

import org.jspecify.annotations.NullMarked;
