/**
 * Text from other computers, made safe to be shown.
 *
 * <p>Names, notes and error messages of modules are written by whoever runs them. {@link
 * org.dfra.text.PrintableText} is applied to each such text before it reaches a terminal, a log, a
 * page or a picture.
 */
@NullMarked
package org.dfra.text;

import org.jspecify.annotations.NullMarked;
