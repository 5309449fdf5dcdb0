/**
 * How a robot is written down: its XML, the properties of its modules, their parameters.
 *
 * <p>Enter at {@link org.dfra.core.config.Parameters} for a driver's view.
 */
@NullMarked
package org.dfra.core.config;

import org.jspecify.annotations.NullMarked;
