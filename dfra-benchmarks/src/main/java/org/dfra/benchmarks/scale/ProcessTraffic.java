package org.dfra.benchmarks.scale;

import java.util.Collection;

/**
 * What a process has sent and received since its start or, after {@link #perSecond}, in a second.
 *
 * @param callsSent number of calls that it made
 * @param callsServed number of calls that it answered
 * @param bytesSent bytes
 * @param bytesReceived bytes
 * @param threads number of its Java threads now
 */
record ProcessTraffic(
    double callsSent, double callsServed, double bytesSent, double bytesReceived, int threads) {

  /** The words of a line that {@link TeamView} prints, without the first. */
  static ProcessTraffic parse(String line) {
    String[] words = line.split(" ", -1);
    return new ProcessTraffic(
        Double.parseDouble(words[0]),
        Double.parseDouble(words[1]),
        Double.parseDouble(words[2]),
        Double.parseDouble(words[3]),
        Integer.parseInt(words[4]));
  }

  /** The mean in each second since an earlier time. */
  ProcessTraffic perSecond(ProcessTraffic earlier, double seconds) {
    return new ProcessTraffic(
        (callsSent - earlier.callsSent) / seconds,
        (callsServed - earlier.callsServed) / seconds,
        (bytesSent - earlier.bytesSent) / seconds,
        (bytesReceived - earlier.bytesReceived) / seconds,
        threads);
  }

  /** Bytes in both directions. */
  double bytes() {
    return bytesSent + bytesReceived;
  }

  /** The sum over processes, also of their threads. */
  static ProcessTraffic sum(Collection<ProcessTraffic> all) {
    return all.stream()
        .reduce(
            new ProcessTraffic(0, 0, 0, 0, 0),
            (one, other) ->
                new ProcessTraffic(
                    one.callsSent + other.callsSent,
                    one.callsServed + other.callsServed,
                    one.bytesSent + other.bytesSent,
                    one.bytesReceived + other.bytesReceived,
                    one.threads + other.threads));
  }
}
