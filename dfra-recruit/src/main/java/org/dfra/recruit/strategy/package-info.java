/**
 * Who answers a call and who is chosen: {@link org.dfra.recruit.strategy.RecruitmentStrategy}. A
 * new one is one class; {@link org.dfra.recruit.strategy.StrategyRegistry} knows those that are
 * named in configuration.
 */
@NullMarked
package org.dfra.recruit.strategy;

import org.jspecify.annotations.NullMarked;
