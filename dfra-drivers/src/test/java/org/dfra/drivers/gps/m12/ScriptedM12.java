package org.dfra.drivers.gps.m12;

import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.drivers.fixture.Modules.context;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.time.Instant;
import java.time.LocalDateTime;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.dfra.drivers.fixture.Frames;
import org.dfra.drivers.fixture.Modules;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.fixture.ScriptedLinks;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.slf4j.LoggerFactory;

/** An M12+ driver alone: the test is the receiver and the time. */
@Timeout(120)
abstract class ScriptedM12 {

  static final String URL = "tcp://receiver:4001";
  static final LocalDateTime TIME = LocalDateTime.of(2026, 1, 21, 7, 33, 29);
  static final Instant HOST = Instant.parse("2026-01-21T07:33:29.400Z");
  static final byte[] FIX = Frames.ha(TIME, 52.91, 6.86, Frames.FIX_3D);
  static final byte[] NO_FIX = Frames.ha(TIME, 0, 0, Frames.ACQUIRING);

  /** How many commands the driver sends when the link is open. */
  static final int ORDERS = 9;

  final StepTicker ticker = new StepTicker(false);
  final ScriptedLinks links = new ScriptedLinks(URL);
  final ListAppender<ILoggingEvent> logged = new ListAppender<>();
  final Logger log = (Logger) LoggerFactory.getLogger("dfra.atrv1.gps_front");
  final ScriptedLink link = new ScriptedLink(URL);
  final M12PlusImpl gps = driver(Map.of("link", URL));

  @BeforeEach
  void listen() {
    logged.list = new CopyOnWriteArrayList<>();
    logged.start();
    log.addAppender(logged);
    log.setAdditive(false);
    links.add(link);
  }

  @AfterEach
  void end() {
    gps.close();
    log.detachAppender(logged);
  }

  M12PlusImpl driver(Map<String, String> texts) {
    return new M12PlusImpl(context("gps_front", texts, () -> HOST), ticker, links);
  }

  void awaitReadiness(Readiness expected) {
    Modules.awaitReadiness(gps, expected);
  }

  List<String> warnings() {
    return logged.list.stream()
        .filter(event -> event.getLevel().isGreaterOrEqual(Level.WARN))
        .map(ILoggingEvent::getFormattedMessage)
        .toList();
  }

  static void assertRefuses(ThrowingCallable ask, String message) {
    assertThatThrownBy(ask).isInstanceOf(NotReadyException.class).hasMessage(message);
  }
}
