package org.dfra.drivers.gps.m12;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * {@code @@Cj}: the receiver's identification. Texts as received, trimmed; empty where missing.
 * They are found by their labels, because the columns differ between firmwares.
 *
 * @param copyright the first line
 * @param softwarePartNumber {@code SFTW P/N #}
 * @param softwareVersion {@code SOFTWARE VER #}
 * @param softwareRevision {@code SOFTWARE REV #}
 * @param softwareDate {@code SOFTWARE DATE}
 * @param model {@code MODEL #}
 * @param hardwarePartNumber {@code HWDR P/N #}
 * @param serialNumber {@code SERIAL #}
 * @param manufactureDate {@code MANUFACTUR DATE}
 * @param options {@code OPTIONS LIST}, with the lines after it
 */
public record ReceiverIdentification(
    String copyright,
    String softwarePartNumber,
    String softwareVersion,
    String softwareRevision,
    String softwareDate,
    String model,
    String hardwarePartNumber,
    String serialNumber,
    String manufactureDate,
    String options)
    implements M12Message {

  @Override
  public String id() {
    return "Cj";
  }

  /** Parses the text of the message. */
  static ReceiverIdentification of(byte[] bytes, int from, int to) {
    String text = new String(bytes, from, to - from, StandardCharsets.US_ASCII);
    List<String> lines =
        new ArrayList<>(text.lines().map(ReceiverIdentification::cleaned).toList());
    return new ReceiverIdentification(
        lines.isEmpty() ? "" : lines.get(0),
        take(lines, "SFTW P/N #"),
        take(lines, "SOFTWARE VER #"),
        take(lines, "SOFTWARE REV #"),
        take(lines, "SOFTWARE DATE"),
        take(lines, "MODEL #"),
        take(lines, "HWDR P/N #"),
        take(lines, "SERIAL #"),
        take(lines, "MANUFACTUR DATE"),
        takeRest(lines, "OPTIONS LIST"));
  }

  private static String take(List<String> lines, String label) {
    for (String line : lines) {
      if (line.toUpperCase(Locale.ROOT).startsWith(label)) {
        return line.substring(label.length()).strip();
      }
    }
    return "";
  }

  private static String takeRest(List<String> lines, String label) {
    for (int i = 0; i < lines.size(); i++) {
      if (lines.get(i).toUpperCase(Locale.ROOT).startsWith(label)) {
        return String.join(" ", lines.subList(i, lines.size())).substring(label.length()).strip();
      }
    }
    return "";
  }

  /** Replaces each run of blanks and unprintable characters by one blank, and trims the line. */
  private static String cleaned(String line) {
    return line.replaceAll("[^\\x21-\\x7E]+", " ").strip();
  }
}
