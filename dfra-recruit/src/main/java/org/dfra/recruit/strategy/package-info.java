/**
 * Strategies, which determine the robots that answer a call and the one chosen: {@link
 * org.dfra.recruit.strategy.RecruitmentStrategy}. A new one is one class; {@link
 * org.dfra.recruit.strategy.StrategyRegistry} resolves the names in the configuration.
 */
@NullMarked
package org.dfra.recruit.strategy;

import org.jspecify.annotations.NullMarked;
