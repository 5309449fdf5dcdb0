package org.dfra.directory;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.dfra.flow.sensor.GPSSensor;

/** Records each notification. */
class RecordingDirectoryListener implements DirectoryListener<GPSSensor> {
  final BlockingQueue<String> lines = new LinkedBlockingQueue<>();

  @Override
  public void matched(ModuleListing<GPSSensor> listing) {
    lines.add("matched " + listing.name());
  }

  @Override
  public void changed(ModuleListing<GPSSensor> before, ModuleListing<GPSSensor> now) {
    lines.add("changed " + now.name() + (now.stale() ? " stale" : ""));
  }

  @Override
  public void unmatched(ModuleListing<GPSSensor> last) {
    lines.add("unmatched " + last.name());
  }

  String next() throws InterruptedException {
    return lines.poll(DirectoryFixture.PATIENCE.toSeconds(), TimeUnit.SECONDS);
  }
}
