/**
 * Puts {@code java.rmi.activation} on the boot class path, the only place where it may be defined.
 *
 * <p>Start at {@link org.dfra.activation.BootPathAgent}, which the manifest of this jar names.
 * {@link org.dfra.activation.GroupPorts} closes what a group has opened.
 */
@NullMarked
package org.dfra.activation;

import org.jspecify.annotations.NullMarked;
