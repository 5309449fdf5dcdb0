package org.dfra.core.budget;

import java.util.Locale;

/** What calls use up per second. */
public enum BudgetResource {
  /** Bytes on the network. */
  BYTES,
  /** Calls. */
  CALLS,
  /** Processor time, in seconds. */
  PROCESSOR_TIME;

  /**
   * A rate in words, such as {@code 64 kB/s}.
   *
   * @param rate per second, in the unit of the resource
   */
  public String inWords(double rate) {
    return switch (this) {
      case BYTES -> bytes(rate);
      case CALLS -> number(rate) + " calls/s";
      case PROCESSOR_TIME -> number(rate * 1000) + " ms/s of processor time";
    };
  }

  private static String bytes(double rate) {
    if (rate < 1000) {
      return number(rate) + " B/s";
    }
    return rate < 1e6 ? number(rate / 1000) + " kB/s" : number(rate / 1e6) + " MB/s";
  }

  private static String number(double value) {
    String text = String.format(Locale.ROOT, "%.1f", value);
    return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
  }
}
