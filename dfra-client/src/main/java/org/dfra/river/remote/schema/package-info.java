/** What clients may call on perceptual and motor schemas over the network. */
@NullMarked
package org.dfra.river.remote.schema;

import org.jspecify.annotations.NullMarked;
