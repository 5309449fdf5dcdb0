/**
 * What every module implementation is built on.
 *
 * <p>Enter at {@link org.dfra.core.module.ModuleImpl}, the last of the five classes: the driver. It
 * talks to hardware and knows no network. It is constructed with a {@link
 * org.dfra.core.module.ModuleContext}, started once and closed once.
 */
@NullMarked
package org.dfra.core.module;

import org.jspecify.annotations.NullMarked;
