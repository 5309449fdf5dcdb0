package org.dfra.cli.log;

import ch.qos.logback.classic.pattern.Abbreviator;
import ch.qos.logback.classic.pattern.TargetLengthBasedClassNameAbbreviator;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.IThrowableProxy;
import ch.qos.logback.core.encoder.EncoderBase;
import java.nio.charset.Charset;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.ZoneOffset;
import org.dfra.text.PrintableText;

/**
 * Formats an event as a log line and, if there is an exception, its lines after it, like Logback's
 * pattern {@value #PATTERN}, but {@linkplain PrintableText printable}: a message is one line,
 * whatever text another computer has put into it. For a pattern, Logback loads about a hundred
 * converter classes in every process.
 */
final class LineEncoder extends EncoderBase<ILoggingEvent> {

  /** The equivalent Logback pattern. */
  static final String PATTERN =
      "%d{yyyy-MM-dd'T'HH:mm:ss.SSSXXX} %-5level [%thread] %logger{24}: %msg%n";

  private static final int NAME_LENGTH = 24;
  private static final int LEVEL_LENGTH = 5;
  private static final int USUAL_LENGTH = 160;

  private final Abbreviator names = new TargetLengthBasedClassNameAbbreviator(NAME_LENGTH);
  private final ZoneId zone = ZoneId.systemDefault();

  @Override
  public byte[] headerBytes() {
    return new byte[0];
  }

  @Override
  public byte[] footerBytes() {
    return new byte[0];
  }

  @Override
  public byte[] encode(ILoggingEvent event) {
    StringBuilder line = new StringBuilder(USUAL_LENGTH);
    appendTime(line, event.getTimeStamp());
    String level = event.getLevel().toString();
    line.append(' ').append(level).append(" ".repeat(Math.max(0, LEVEL_LENGTH - level.length())));
    line.append(" [").append(PrintableText.name(event.getThreadName())).append("] ");
    line.append(PrintableText.name(names.abbreviate(event.getLoggerName()))).append(": ");
    String message = String.valueOf(event.getFormattedMessage());
    line.append(PrintableText.line(message)).append(System.lineSeparator());
    IThrowableProxy thrown = event.getThrowableProxy();
    if (thrown != null) {
      PrintableTrace.append(line, thrown);
    }
    return line.toString().getBytes(Charset.defaultCharset());
  }

  private void appendTime(StringBuilder line, long millis) {
    Instant instant = Instant.ofEpochMilli(millis);
    ZoneOffset offset = zone.getRules().getOffset(instant);
    LocalDateTime time =
        LocalDateTime.ofEpochSecond(instant.getEpochSecond(), instant.getNano(), offset);
    append(line, time.getYear(), 4).append('-');
    append(line, time.getMonthValue(), 2).append('-');
    append(line, time.getDayOfMonth(), 2).append('T');
    append(line, time.getHour(), 2).append(':');
    append(line, time.getMinute(), 2).append(':');
    append(line, time.getSecond(), 2).append('.');
    append(line, time.getNano() / 1_000_000, 3).append(offset.getId());
  }

  private static StringBuilder append(StringBuilder line, int number, int digits) {
    String text = Integer.toString(number);
    return line.append("0".repeat(Math.max(0, digits - text.length()))).append(text);
  }
}
