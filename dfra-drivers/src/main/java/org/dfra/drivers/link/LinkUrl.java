package org.dfra.drivers.link;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * The parts of a link's URL: {@code scheme:target?key=value&key=value}. The target is taken
 * literally, without escapes, so that file names need none.
 */
record LinkUrl(String url, String scheme, String target, Map<String, String> options) {

  static final String ALLOWED =
      "write serial:/dev/ttyS0?baud=9600, tcp://host:port, replay:file?pace=1.0 or sim:name";

  static LinkUrl split(String url) {
    int colon = url.indexOf(':');
    if (colon <= 0) {
      throw new IllegalArgumentException(
          "link \"" + url + "\": it begins with no scheme; " + ALLOWED);
    }
    int question = url.indexOf('?');
    String target = question < 0 ? url.substring(colon + 1) : url.substring(colon + 1, question);
    LinkUrl parts =
        new LinkUrl(url, url.substring(0, colon), target, new TreeMap<String, String>());
    if (question >= 0) {
      for (String option : url.substring(question + 1).split("&", -1)) {
        parts.add(option);
      }
    }
    return parts;
  }

  private void add(String option) {
    int equals = option.indexOf('=');
    if (equals <= 0 || equals == option.length() - 1) {
      throw fault("the option \"" + option + "\" is not of the form name=value");
    }
    String name = option.substring(0, equals);
    if (options.put(name, option.substring(equals + 1)) != null) {
      throw fault("the option " + name + " is given twice; keep one of them");
    }
  }

  /** Rejects every option that is not one of {@code names}. */
  void allow(Set<String> names) {
    for (String name : options.keySet()) {
      if (!names.contains(name)) {
        throw fault("the option " + name + " is unknown; " + scheme + " takes " + listed(names));
      }
    }
  }

  int whole(String name, int fallback, int min, int max) {
    String text = options.get(name);
    if (text == null) {
      return fallback;
    }
    String expected = "a whole number from " + min + " to " + max;
    try {
      int number = Integer.parseInt(text);
      if (number < min || number > max) {
        throw fault(name + " is \"" + text + "\", which is not " + expected);
      }
      return number;
    } catch (NumberFormatException e) {
      throw fault(name + " is \"" + text + "\", which is not " + expected);
    }
  }

  /** Reads a finite number that is at least {@code min}. */
  double number(String name, double fallback, double min) {
    String text = options.get(name);
    if (text == null) {
      return fallback;
    }
    double number;
    try {
      number = Double.parseDouble(text);
    } catch (NumberFormatException e) {
      number = Double.NaN;
    }
    if (!(number >= min) || Double.isInfinite(number)) {
      throw fault(name + " is \"" + text + "\", which is not a number of " + min + " or more");
    }
    return number;
  }

  /** Reads one of the allowed words of an option. */
  String word(String name, String fallback, Set<String> words) {
    String text = options.getOrDefault(name, fallback);
    if (!words.contains(text)) {
      throw fault(name + " is \"" + text + "\"; allowed are " + listed(words));
    }
    return text;
  }

  IllegalArgumentException fault(String what) {
    return new IllegalArgumentException("link \"" + url + "\": " + what);
  }

  private static String listed(Set<String> words) {
    return words.isEmpty() ? "no options" : String.join(", ", new TreeSet<>(words));
  }
}
