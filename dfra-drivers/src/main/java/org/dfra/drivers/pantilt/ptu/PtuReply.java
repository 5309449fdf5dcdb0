package org.dfra.drivers.pantilt.ptu;

import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.drivers.pantilt.ptu.PtuCommands.PtuAxis;

/**
 * A reply of the unit. Replies arrive in the order of the commands; a {@link LimitHit} at any time.
 */
sealed interface PtuReply {

  /** {@code *}: the command was executed, or is being executed. */
  record Done() implements PtuReply {}

  /**
   * {@code * text}: the answer to a question.
   *
   * @param text only the number in terse mode, else a sentence
   */
  record Value(String text) implements PtuReply {

    /** Does not match the 46 of {@code D46}, nor the 2.14 of {@code v2.14.0}. */
    private static final Pattern NUMBER =
        Pattern.compile("(?<![\\w.])-?[0-9]{1,9}(\\.[0-9]{1,9})?(?![\\w.])");

    /** The number in the text, if there is exactly one. */
    public OptionalDouble number() {
      Matcher matcher = NUMBER.matcher(text);
      if (!matcher.find()) {
        return OptionalDouble.empty();
      }
      double number = Double.parseDouble(matcher.group());
      return matcher.find() ? OptionalDouble.empty() : OptionalDouble.of(number);
    }
  }

  /**
   * {@code ! text}: the command was not executed.
   *
   * @param message why, in the unit's words
   */
  record Refused(String message) implements PtuReply {}

  /**
   * {@code !P} or {@code !T}, unsolicited: the axis ran into its end stop. The unit has lost steps,
   * so its direction is unknown until it is reset.
   *
   * @param axis the axis
   */
  record LimitHit(PtuAxis axis) implements PtuReply {}
}
