package org.dfra.benchmarks.micro;

import java.util.concurrent.TimeUnit;
import org.dfra.drivers.frame.FrameParser;
import org.dfra.drivers.gps.m12.M12Parser;
import org.dfra.drivers.gps.nmea.NmeaParser;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/**
 * The receivers' parsers. An operation parses all bytes that an emulated receiver sends in five
 * minutes ({@link DeviceRecording}), in pieces of a driver's buffer. Microseconds.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class ParserBenchmark {

  private long messages;
  private final byte[] m12 = DeviceRecording.m12();
  private final byte[] nmea = DeviceRecording.nmea();
  private final M12Parser m12Parser = new M12Parser(message -> messages++);
  private final NmeaParser nmeaParser = new NmeaParser(message -> messages++);

  /** For JMH. */
  public ParserBenchmark() {}

  /** Motorola's binary protocol, that of an M12+. Returns the number of messages so far. */
  @Benchmark
  public long motorola() {
    return parse(m12Parser, m12);
  }

  /** NMEA 0183. Returns the number of sentences so far. */
  @Benchmark
  public long nmea() {
    return parse(nmeaParser, nmea);
  }

  private long parse(FrameParser<?> parser, byte[] recording) {
    for (int at = 0; at < recording.length; at += DeviceRecording.BUFFER_BYTES) {
      parser.feed(recording, at, Math.min(DeviceRecording.BUFFER_BYTES, recording.length - at));
    }
    return messages;
  }
}
