/**
 * Text from other computers, made safe to display.
 *
 * <p>Names, notes and error messages of remote modules are untrusted. {@link
 * org.dfra.text.PrintableText} is applied to each such text before it reaches a terminal, a log, a
 * page or an image.
 */
@NullMarked
package org.dfra.text;

import org.jspecify.annotations.NullMarked;
