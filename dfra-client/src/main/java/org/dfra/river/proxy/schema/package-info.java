/**
 * Smart proxies of perceptual and motor schemas. Enter at {@link
 * org.dfra.river.proxy.schema.SchemaProxy}.
 */
@NullMarked
package org.dfra.river.proxy.schema;

import org.jspecify.annotations.NullMarked;
