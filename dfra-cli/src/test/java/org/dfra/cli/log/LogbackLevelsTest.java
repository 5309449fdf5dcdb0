package org.dfra.cli.log;

import static org.assertj.core.api.Assertions.assertThat;

import org.dfra.core.log.LogLevelControl;
import org.dfra.module.LogLevel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.slf4j.LoggerFactory;

class LogbackLevelsTest {

  private static final String LOGGER = "dfra.atrv1.lamp";

  @ParameterizedTest
  @EnumSource(LogLevel.class)
  void setsALevelThatCountsAtOnce(LogLevel level) {
    LogLevelControl levels = LogLevelControl.service();
    assertThat(levels).isInstanceOf(LogbackLevels.class);
    levels.set(LOGGER, level);
    assertThat(levels.level(LOGGER)).isEqualTo(level);
    assertThat(LoggerFactory.getLogger(LOGGER).isDebugEnabled())
        .isEqualTo(level.compareTo(LogLevel.DEBUG) <= 0);
  }

  @Test
  void aLoggerInheritsItsLevel() {
    LogLevelControl.service().set("dfra.atrv7", LogLevel.WARN);
    assertThat(LogLevelControl.service().level("dfra.atrv7.lamp")).isEqualTo(LogLevel.WARN);
  }
}
