package org.dfra.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.ConnectException;
import java.net.InetAddress;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import net.jini.core.discovery.LookupLocator;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import org.junit.jupiter.api.Test;

class EmbeddedRegistrarTest {

  /** As where a robot's name leads to its loopback, and it listens at its radio's address. */
  private static final String ELSEWHERE = "127.0.0.2";

  @Test
  void endsWhereTheComputersNameLeadsToAnotherAddress() throws Exception {
    assertThat(InetAddress.getLocalHost()).isNotEqualTo(InetAddress.getByName(ELSEWHERE));
    EmbeddedRegistrar registrar =
        new EmbeddedRegistrar(ELSEWHERE, 0, List.of(), Duration.ofSeconds(5), Map.of()).start();
    LookupLocator locator = new LookupLocator(registrar.locator());
    assertThat(locator.getRegistrar()).isEqualTo(registrar.registrar());
    assertThatCode(registrar::close).doesNotThrowAnyException();
    assertThatThrownBy(locator::getRegistrar).isInstanceOf(ConnectException.class);
    assertThat(registrar.registrarIfRunning()).isEmpty();
  }
}
