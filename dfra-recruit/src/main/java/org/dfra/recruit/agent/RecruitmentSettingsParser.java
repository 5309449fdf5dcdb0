package org.dfra.recruit.agent;

import java.time.Duration;
import java.util.Optional;
import org.dfra.core.config.Parameters;
import org.dfra.recruit.RecruitmentSettings;
import org.jspecify.annotations.Nullable;

/** Reads an agent's timeouts from its parameters. */
final class RecruitmentSettingsParser {

  private static final Duration SHORTEST = Duration.ofMillis(100);
  private static final Duration LONGEST = Duration.ofHours(1);
  private static final Duration LONGEST_WINDOW = Duration.ofSeconds(10);
  private static final RecruitmentSettings USUAL = RecruitmentSettings.DEFAULT;

  private final Parameters settings;

  private RecruitmentSettingsParser(Parameters settings) {
    this.settings = settings;
  }

  /**
   * The parameters set, with DFRA's defaults for the others.
   *
   * @throws org.dfra.core.config.ConfigurationException naming the invalid parameter and its place
   */
  static RecruitmentSettings of(Parameters settings) {
    RecruitmentSettingsParser read = new RecruitmentSettingsParser(settings);
    Duration replaceAfter = read.span("replace_after", USUAL.replaceAfter());
    Duration margin = read.span("margin", USUAL.margin());
    if (replaceAfter.compareTo(margin) <= 0) {
      throw read.turnsBackTooEarly(replaceAfter, margin);
    }
    return new RecruitmentSettings(
        read.span("help_every", USUAL.helpEvery()),
        read.count("help_rounds", USUAL.roundsPerConversation()),
        replaceAfter,
        margin,
        read.span("repeat_every", USUAL.repeatEvery()),
        read.count("accept_sends", USUAL.acceptSends()),
        read.count("arrival_sends", USUAL.arrivalSends()),
        read.span("agree_every", USUAL.agreeEvery()),
        read.span("release_every", USUAL.releaseEvery()),
        read.window(replaceAfter.minus(margin)));
  }

  private Duration span(String name, Duration usual) {
    return settings.seconds(name, usual, SHORTEST, LONGEST);
  }

  /**
   * The value set; null where none is.
   *
   * @param tooLong limit from which on a robot that offered could not arrive in time
   */
  private @Nullable Duration window(Duration tooLong) {
    if (settings.find("offer_window").isEmpty()) {
      return null;
    }
    Duration window = settings.seconds("offer_window", SHORTEST, SHORTEST, LONGEST_WINDOW);
    if (window.compareTo(tooLong) >= 0) {
      throw settings.fault(
          "offer_window", "below replace_after less margin, " + seconds(tooLong), null);
    }
    return window;
  }

  private int count(String name, int usual) {
    double number = settings.number(name, usual, 1, 100);
    if (number != Math.rint(number)) {
      throw settings.fault(name, "a whole number", null);
    }
    return (int) number;
  }

  /** At least one of the two is set, since the defaults are consistent. */
  private RuntimeException turnsBackTooEarly(Duration replaceAfter, Duration margin) {
    Optional<String> written = settings.find("margin");
    return written.isPresent()
        ? settings.fault("margin", "below replace_after, " + seconds(replaceAfter), null)
        : settings.fault("replace_after", "above margin, " + seconds(margin), null);
  }

  private static String seconds(Duration span) {
    return span.toMillis() / 1000.0 + " s";
  }
}
