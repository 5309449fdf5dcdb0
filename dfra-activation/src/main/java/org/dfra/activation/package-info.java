/**
 * Puts {@code java.rmi.activation} on the boot class path, where alone it may be defined.
 *
 * <p>Enter at {@link org.dfra.activation.BootPathAgent}, which the manifest of this jar names; it
 * has nothing else to offer.
 */
@NullMarked
package org.dfra.activation;

import org.jspecify.annotations.NullMarked;
