package org.dfra.drivers.link;

import com.fazecast.jSerialComm.SerialPort;
import java.io.IOException;
import java.util.Map;
import java.util.Set;

/**
 * A serial port of this computer: {@code serial:/dev/ttyS0?baud=9600&bits=8&parity=none&stop=1}.
 * All options are optional; the values shown are the defaults. No flow control.
 *
 * @param url the URL as configured
 * @param port the port's name or path
 * @param baud bits per second on the line
 * @param bits data bits per character, 5 to 8
 * @param parity {@code none}, {@code even}, {@code odd}, {@code mark} or {@code space}
 * @param stop stop bits: {@code 1}, {@code 1.5} or {@code 2}
 */
public record SerialAddress(String url, String port, int baud, int bits, String parity, String stop)
    implements LinkAddress {

  private static final Map<String, Integer> PARITIES =
      Map.of(
          "none", SerialPort.NO_PARITY,
          "even", SerialPort.EVEN_PARITY,
          "odd", SerialPort.ODD_PARITY,
          "mark", SerialPort.MARK_PARITY,
          "space", SerialPort.SPACE_PARITY);
  private static final Map<String, Integer> STOPS =
      Map.of(
          "1", SerialPort.ONE_STOP_BIT,
          "1.5", SerialPort.ONE_POINT_FIVE_STOP_BITS,
          "2", SerialPort.TWO_STOP_BITS);

  static SerialAddress of(LinkUrl parts) {
    parts.allow(Set.of("baud", "bits", "parity", "stop"));
    if (parts.target().isBlank()) {
      throw parts.fault("it names no port; write serial:/dev/ttyS0?baud=9600");
    }
    return new SerialAddress(
        parts.url(),
        parts.target(),
        parts.whole("baud", 9600, 50, 4_000_000),
        parts.whole("bits", 8, 5, 8),
        parts.word("parity", "none", PARITIES.keySet()),
        parts.word("stop", "1", STOPS.keySet()));
  }

  @Override
  public SerialLink open(Ticker ticker) throws IOException {
    return SerialPortLink.open(this, PARITIES.getOrDefault(parity, 0), STOPS.getOrDefault(stop, 1));
  }

  @Override
  public String toString() {
    return url;
  }
}
