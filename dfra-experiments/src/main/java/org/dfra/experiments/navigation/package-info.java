/**
 * A range filter for studies of navigation, and the confidence of what was counted. Entry point:
 * {@link org.dfra.experiments.navigation.ConfidenceInterval}.
 */
@NullMarked
package org.dfra.experiments.navigation;

import org.jspecify.annotations.NullMarked;
