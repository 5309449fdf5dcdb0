package org.dfra.cli.log;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.encoder.PatternLayoutEncoder;
import ch.qos.logback.classic.spi.Configurator.ExecutionStatus;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.LoggingEvent;
import ch.qos.logback.core.Appender;
import ch.qos.logback.core.ConsoleAppender;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TimeZone;
import org.dfra.river.bootstrap.JvmCommand;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.slf4j.LoggerFactory;
import org.slf4j.bridge.SLF4JBridgeHandler;

class LogbackSetupTest {

  @TempDir Path folder;

  /** A process that logs. */
  static final class Talker {
    public static void main(String[] args) {
      SLF4JBridgeHandler.removeHandlersForRootLogger();
      SLF4JBridgeHandler.install();
      LoggerFactory.getLogger("org.dfra.cli.log.Talker").info("by SLF4J");
      LoggerFactory.getLogger("org.dfra.cli.log.Talker").debug("in detail");
      java.util.logging.Logger.getLogger("net.jini.Talker").fine("by java.util.logging");
    }
  }

  private String output(Map<String, String> environment, List<String> options, Path... before)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(JvmCommand.java()));
    command.addAll(JvmCommand.options());
    for (Path each : before) {
      command.set(command.size() - 1, each + ":" + command.get(command.size() - 1));
    }
    command.addAll(options);
    command.add(Talker.class.getName());
    Path out = folder.resolve("out");
    ProcessBuilder process =
        new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(out.toFile());
    process.environment().remove(LogbackSetup.LEVEL);
    process.environment().putAll(environment);
    assertThat(process.start().waitFor()).isZero();
    return Files.readString(out, StandardCharsets.UTF_8);
  }

  @Test
  void aProcessLogsToItsStandardOutput() throws Exception {
    assertThat(output(Map.of(), List.of()))
        .matches(
            "\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d\\.\\d{3}(Z|[+-]\\d\\d:\\d\\d)"
                + " INFO  \\[main\\] org\\.dfra\\.cli\\.log\\.Talker: by SLF4J\\R");
  }

  @Test
  void theLevelComesFromTheEnvironmentAndReachesJavaUtilLogging() throws Exception {
    assertThat(output(Map.of(LogbackSetup.LEVEL, "DEBUG"), List.of()))
        .containsSubsequence("by SLF4J", "in detail", "by java.util.logging");
    assertThat(output(Map.of(LogbackSetup.LEVEL, "DEBUG"), List.of("-DDFRA_LOG=WARN")))
        .as("the property counts first")
        .isEmpty();
  }

  @Test
  void saysWhichLevelIsNone() throws Exception {
    assertThat(output(Map.of(LogbackSetup.LEVEL, "loud"), List.of()))
        .startsWith("dfra: DFRA_LOG=loud is not a log level; INFO is used: set ERROR,")
        .contains("by SLF4J")
        .doesNotContain("in detail");
  }

  @Test
  void aConfigurationOfTheUserIsUsed() throws Exception {
    String xml =
        """
        <configuration>
          <appender name="a" class="ch.qos.logback.core.ConsoleAppender">
            <encoder><pattern>mine: %msg%n</pattern></encoder>
          </appender>
          <root level="INFO"><appender-ref ref="a"/></root>
        </configuration>
        """;
    Path named = Files.writeString(folder.resolve("named.xml"), xml);
    Path path = Files.createDirectory(folder.resolve("classes"));
    assertThat(output(Map.of(), List.of("-Dlogback.configurationFile=" + named)))
        .isEqualTo("mine: by SLF4J\n");
    Files.writeString(path.resolve("logback.xml"), xml);
    assertThat(output(Map.of(), List.of(), path)).isEqualTo("mine: by SLF4J\n");
  }

  @ParameterizedTest
  @CsvSource({"ERROR, ERROR", "warn, WARN", "' TRACE ', TRACE", "OFF, OFF"})
  void readsALevel(String given, String level) {
    assertThat(LogbackSetup.level(Optional.of(given))).isEqualTo(Level.toLevel(level));
  }

  /** The encoder stands for a pattern, whose converters would be loaded in every process. */
  @ParameterizedTest
  @CsvSource({
    "org.dfra.river.phoenix.Phoenix, INFO, 0",
    "Short, ERROR, 1732360000007",
    "org.dfra.a.very.deep.package.of.classes.Name, WARN, 1721912400120"
  })
  void theLinesAreThoseOfThePattern(String logger, String level, long millis) {
    LoggerContext context = new LoggerContext();
    PatternLayoutEncoder pattern = new PatternLayoutEncoder();
    pattern.setContext(context);
    pattern.setPattern(LineEncoder.PATTERN);
    pattern.start();
    TimeZone here = TimeZone.getDefault();
    try {
      for (String zone : List.of("UTC", "Europe/Berlin", "America/St_Johns")) {
        TimeZone.setDefault(TimeZone.getTimeZone(zone));
        pattern.stop();
        pattern.start();
        LineEncoder encoder = new LineEncoder();
        encoder.start();
        for (Throwable thrown :
            new Throwable[] {null, new IOException("full ü", new IllegalStateException("why"))}) {
          LoggingEvent event =
              new LoggingEvent(
                  "",
                  context.getLogger(logger),
                  Level.toLevel(level),
                  "{} % of {}",
                  thrown,
                  new Object[] {7, "x"});
          event.setInstant(Instant.ofEpochMilli(millis));
          assertThat(new String(encoder.encode(event), Charset.defaultCharset()))
              .isEqualTo(new String(pattern.encode(event), Charset.defaultCharset()))
              .contains("7 % of x");
        }
      }
    } finally {
      TimeZone.setDefault(here);
    }
  }

  /** A name that another computer chose goes into a message, an exception and its frames. */
  @Test
  void anEventIsOneLineWhateverItsTextHolds() {
    String name = "gps\n2026-11-23T16:00:00.000Z INFO forged: 2 stopped\u001b[2J\u009b\u202e";
    String shown = "gps\\n2026-11-23T16:00:00.000Z INFO forged: 2 stopped\\u001b[2J\\u009b\\u202e";
    IOException thrown = new IOException(name, new IllegalStateException(name));
    thrown.setStackTrace(
        new StackTraceElement[] {new StackTraceElement("a.B\nforged", "c\u001b", "B.java", 1)});
    thrown.addSuppressed(new IllegalArgumentException(name));
    LoggerContext context = new LoggerContext();
    LineEncoder encoder = new LineEncoder();
    encoder.start();
    LoggingEvent event =
        new LoggingEvent(
            "", context.getLogger(name), Level.WARN, "{} left", thrown, new Object[] {name});
    event.setThreadName(name);
    event.setInstant(Instant.EPOCH);
    String text = new String(encoder.encode(event), Charset.defaultCharset());
    assertThat(text)
        .contains("WARN  [" + shown + "] ", ": " + shown + " left")
        .contains("java.io.IOException: " + shown)
        .contains("\tat a.B\\nforged.c\\u001b(B.java:1)")
        .contains("\tSuppressed: java.lang.IllegalArgumentException: " + shown)
        .contains("Caused by: java.lang.IllegalStateException: " + shown)
        .doesNotContainPattern("[\\p{Cc}\\p{Cf}&&[^\n\t]]")
        .doesNotContainPattern("(?m)^(?:2026-11-23|forged|2 stopped)");
  }

  @Test
  void isWhatThisProcessIsSetUpBy() {
    LoggerContext context = (LoggerContext) LoggerFactory.getILoggerFactory();
    Appender<ILoggingEvent> appender = context.getLogger("ROOT").getAppender("out");
    assertThat(appender).isInstanceOf(ConsoleAppender.class);
    assertThat(new LogbackSetup().configure(new LoggerContext()))
        .isEqualTo(ExecutionStatus.DO_NOT_INVOKE_NEXT_IF_ANY);
  }
}
