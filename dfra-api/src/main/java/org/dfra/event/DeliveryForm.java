package org.dfra.event;

import java.io.Externalizable;
import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInput;
import java.io.ObjectOutput;
import java.io.Serial;
import java.time.DateTimeException;
import java.time.Instant;
import org.dfra.event.ModuleEvent.NewReading;
import org.jspecify.annotations.Nullable;

/**
 * The serial form of a {@link Delivery}: its values without a description of each of its fields,
 * which took three times as many bytes as the values. What happened follows as an object: the
 * reading of a {@link NewReading}, and any other event itself.
 */
final class DeliveryForm implements Externalizable {

  @Serial private static final long serialVersionUID = 1;

  private @Nullable Delivery delivery;

  /** For deserialization. */
  public DeliveryForm() {}

  DeliveryForm(Delivery delivery) {
    this.delivery = delivery;
  }

  @Override
  public void writeExternal(ObjectOutput out) throws IOException {
    Delivery written = delivery;
    if (written == null) {
      throw new InvalidObjectException("a delivery that was not read is not written");
    }
    out.writeUTF(written.module());
    out.writeLong(written.epoch());
    out.writeLong(written.sequence());
    out.writeLong(written.dropped());
    out.writeLong(written.published().getEpochSecond());
    out.writeInt(written.published().getNano());
    out.writeObject(
        written.event() instanceof NewReading reading ? reading.reading() : written.event());
  }

  @Override
  public void readExternal(ObjectInput in) throws IOException, ClassNotFoundException {
    String module = in.readUTF();
    long epoch = in.readLong();
    long sequence = in.readLong();
    long dropped = in.readLong();
    long seconds = in.readLong();
    int nanos = in.readInt();
    Object what = in.readObject();
    try {
      delivery =
          new Delivery(
              module, epoch, sequence, dropped, Instant.ofEpochSecond(seconds, nanos), event(what));
    } catch (IllegalArgumentException | DateTimeException e) {
      throw invalid(String.valueOf(e.getMessage()), e);
    }
  }

  private static ModuleEvent event(@Nullable Object what) throws InvalidObjectException {
    if (what instanceof Reading reading) {
      return new NewReading(reading);
    } else if (what instanceof ModuleEvent event) {
      return event;
    }
    throw invalid("a delivery of " + (what == null ? "nothing" : what.getClass().getName()), null);
  }

  private static InvalidObjectException invalid(String reason, @Nullable Exception cause) {
    InvalidObjectException invalid = new InvalidObjectException(reason);
    if (cause != null) {
      invalid.initCause(cause);
    }
    return invalid;
  }

  @Serial
  private Object readResolve() throws InvalidObjectException {
    if (delivery == null) {
      throw new InvalidObjectException("a delivery without its values");
    }
    return delivery;
  }
}
