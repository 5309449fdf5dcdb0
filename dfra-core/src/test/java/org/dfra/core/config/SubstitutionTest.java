package org.dfra.core.config;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SubstitutionTest {

  private static final SourceLocation PLACE = new SourceLocation("robot.xml", 3);

  private final ConfigurationFaults faults = new ConfigurationFaults();
  private final Substitution substitution =
      new Substitution(
          Map.of("HOST", "base", "PORT", "41", "EMPTY", "", "a.b", "dot")::get, faults);

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "plain {text} | plain {text}",
        "${HOST} | base",
        "tcp://${HOST}:${PORT}60 | tcp://base:4160",
        "[${EMPTY}] | []",
        "[${EMPTY:-other}] | [other]",
        "[${NONE:-}] | []",
        "${NONE:-serial:/dev/ttyS0?baud=9600} | serial:/dev/ttyS0?baud=9600",
        "${NONE:-a-:-b} | a-:-b",
        "${NONE:-${HOST}} | base",
        "${NONE:-${NEITHER:-x}}y | xy",
        "${HOST:-${NOT_NEEDED}} | base",
        "${a.b} | dot",
        "$$ | $",
        "$${HOST} | ${HOST}",
        "$$$${HOST}$$ | $${HOST}$",
        "${NONE:-$$} | $",
      })
  void substitutes(String text, String expected) {
    assertThat(substitution.apply(text, PLACE)).isEqualTo(expected);
    faults.throwIfAny();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "$HOST | the dollar in \"$HOST\" begins no variable",
        "100$ | the dollar in \"100$\" begins no variable",
        "x${} | \"${}\" names no variable",
        "${1A} | \"${1A}\" names no variable",
        "x${HOST | \"${HOST\" is not a variable",
        "${HOST-x} | \"${HOST-x}\" is not a variable",
        "${NONE:-x | \"${NONE:-x\" lacks its closing brace",
      })
  void refusesABadEscape(String text, String sentence) {
    assertThat(substitution.apply(text, PLACE)).isNull();

    assertThatThrownBy(faults::throwIfAny)
        .hasMessageStartingWith(
            "robot.xml:3: " + sentence + "; write ${NAME}, ${NAME:-default} or ")
        .hasMessageNotContaining("\n");
  }

  @Test
  void refusesAnUnsetVariableByName() {
    assertThat(substitution.apply("${NONE}", PLACE)).isNull();

    assertThatThrownBy(faults::throwIfAny)
        .hasMessage(
            "robot.xml:3: the variable NONE is not set;"
                + " set it in the environment, or write ${NONE:-default}");
  }

  @ParameterizedTest
  @CsvSource({"$", "$$", "${HOST}", "a$b$$c", "none"})
  void anEscapedTextComesBack(String text) {
    assertThat(substitution.apply(Substitution.escape(text), PLACE)).isEqualTo(text);
  }
}
