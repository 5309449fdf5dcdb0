package org.dfra.drivers.pantilt.ptu;

import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What the unit says. Replies come in the order of the commands; a {@link LimitHit} any time. */
public sealed interface PtuReply {

  /** {@code *}: the command was executed, or is being. */
  record Done() implements PtuReply {}

  /**
   * {@code * text}: the answer to a question.
   *
   * @param text the number alone where the unit is terse, else a sentence
   */
  record Value(String text) implements PtuReply {

    /** Not the 46 of {@code D46}, nor the 2.14 of {@code v2.14.0}. */
    private static final Pattern NUMBER =
        Pattern.compile("(?<![\\w.])-?[0-9]{1,9}(\\.[0-9]{1,9})?(?![\\w.])");

    /** The number in the text, where there is one and no more. */
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
   * {@code !P} or {@code !T}, unasked: the axis ran against its end. The unit has lost count of its
   * steps, and of where it points, until it is reset.
   *
   * @param axis which one
   */
  record LimitHit(PtuAxis axis) implements PtuReply {}
}
