/**
 * Variations of a search for studies of navigation, and the confidence of what was counted. Entry
 * point: {@link org.dfra.experiments.navigation.ScenarioVariations}.
 */
@NullMarked
package org.dfra.experiments.navigation;

import org.jspecify.annotations.NullMarked;
