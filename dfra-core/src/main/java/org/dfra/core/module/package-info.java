/**
 * The base of every module implementation.
 *
 * <p>Start at {@link org.dfra.core.module.ModuleImpl}, the last of the five classes: the driver. It
 * communicates with hardware and is independent of the network. It is constructed with a {@link
 * org.dfra.core.module.ModuleContext}, started once and closed once.
 */
@NullMarked
package org.dfra.core.module;

import org.jspecify.annotations.NullMarked;
