package org.dfra.drivers.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.drivers.frame.StreamCounts;
import org.dfra.drivers.frame.StreamParser;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.junit.jupiter.api.Test;

/** Which clients share a line, and their notifications. No line of these is ever open. */
class SharedLinkRegistryTest {

  private final SharedLinkRegistry<Member, Line> lines = new SharedLinkRegistry<>();
  private final Ticker ticker = new StepTicker(false);
  private final Member first = new Member("first");
  private final Member second = new Member("second");

  @Test
  void makesOneLineForAPlaceAndATime() {
    Line line = join(first, "port");
    assertThat(join(second, "port")).isSameAs(line);
    assertThat(join(new Member("third"), "other port")).isNotSameAs(line);
    StepTicker otherTime = new StepTicker(false);
    assertThat(lines.join(first, "port", otherTime, Line::new, found -> {})).isNotSameAs(line);
    assertThat(line.starts).as("once for each who joined").isEqualTo(2);
    assertThat(line.firstClientPath()).isEqualTo("atrv1/first");
  }

  @Test
  void closesALineWhenTheLastHasLeftAndMakesAnotherThen() {
    Line line = join(first, "port");
    assertThat(join(second, "port")).isSameAs(line);
    line.leave(first);
    assertThat(line.isClosed).isFalse();
    line.leave(second);
    assertThat(line.isClosed).isTrue();
    assertThat(join(first, "port")).isNotSameAs(line);
  }

  @Test
  void goesOnWithoutOneThatDoesNotAgree() {
    Line line = join(first, "port");
    assertThatThrownBy(
            () ->
                lines.join(
                    second,
                    "port",
                    ticker,
                    Line::new,
                    found -> {
                      throw new IllegalStateException("it is not the same");
                    }))
        .hasMessage("it is not the same");
    line.leave(first);
    assertThat(line.isClosed).as("the second has never joined").isTrue();
  }

  @Test
  void notifiesConnectedClientsUntilTheyLeave() {
    Line line = join(first, "port");
    line.clients().dispatch(member -> member.reported.add("too early"));
    line.clients().notifyConnected(member -> member.reported.add("hello"));
    assertThat(join(second, "port")).isSameAs(line);
    line.clients().notifyConnected(member -> member.reported.add("hello"));
    line.clients().dispatch(member -> member.reported.add("news"));
    line.clients().notifyLost("gone");
    line.clients().dispatch(member -> member.reported.add("too late"));
    line.clients().notifyConnected(member -> member.reported.add("hello again"));
    line.leave(second);
    line.clients().notifyLost("gone again");
    assertThat(first.reported)
        .containsExactly("hello", "news", "gone", "hello again", "gone again");
    assertThat(second.reported).containsExactly("hello", "news", "gone", "hello again");
  }

  @Test
  void asksAllWhetherGreetedOrNot() {
    Line line = join(first, "port");
    assertThat(join(second, "port")).isSameAs(line);
    List<String> all = line.clients().query(asked -> asked.stream().map(Member::path).toList());
    assertThat(all).containsExactly("atrv1/first", "atrv1/second");
  }

  private Line join(Member member, String place) {
    return lines.join(member, place, ticker, Line::new, found -> {});
  }

  private static final class Member implements SharedLinkClient {

    private final String name;
    private final List<String> reported = new ArrayList<>();

    Member(String name) {
      this.name = name;
    }

    @Override
    public String path() {
      return "atrv1/" + name;
    }

    @Override
    public void lost(String reason) {
      reported.add(reason);
    }
  }

  private final class Line extends SharedDeviceLink<Member> {

    private final DeviceLink line =
        newDeviceLink(
            new Mute(),
            ticker,
            () -> {
              throw new IOException("there is no such port");
            });
    private int starts;
    private boolean isClosed;

    Line() {
      super(
          lines,
          "mute",
          new ModuleContext(
              "atrv1",
              "first",
              Parameters.of("atrv1/first", Map.of("link", "tcp://mute:1")),
              () -> Instant.parse("2026-11-21T12:00:00Z")));
    }

    @Override
    public DeviceLink deviceLink() {
      return line;
    }

    @Override
    protected void start() {
      starts++;
    }

    @Override
    protected void close() {
      isClosed = true;
    }
  }

  /** A device that says nothing. */
  private static final class Mute implements DeviceProtocol, StreamParser {

    @Override
    public void opened(SerialLink link) {}

    @Override
    public StreamParser parser() {
      return this;
    }

    @Override
    public Duration livenessTimeout() {
      return Duration.ofSeconds(1);
    }

    @Override
    public String expected() {
      return "word";
    }

    @Override
    public void lost(String reason) {}

    @Override
    public void feed(byte[] bytes, int offset, int length) {}

    @Override
    public void finish() {}

    @Override
    public StreamCounts counts() {
      return StreamCounts.ZERO;
    }
  }
}
